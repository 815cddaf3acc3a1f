// Nothing of its own: the target that this file stands for compiles the headers that most files include.
