"""A small scene with everything in it that the window can change, quick to render on any machine."""

SCENE = """image_size 120 90
fov 50
background 0.2 0.3 0.5
rays_per_pixel 4
lens 0.15 5
disk_light 2 5 -1 0.8 0 -1 0 0.9 0.9 0.9
glossy 0.3 0.1 0.1 0.4 0.4 0.4 20 0.4 0.2
sphere 1 -0.8 0 -5
moving_object 0.4 0 0
translucent 0.1 0.3 0.1 0.2 0.2 0.2 30 0.1 0 0.7 1.2 0.2
sphere 0.7 1.2 0 -4
diffuse 0.6 0.6 0.5 0.1 0.1 0.1
begin
vertex -6 -1 0
vertex 6 -1 0
vertex 6 -1 -14
vertex -6 -1 -14
end
"""

BROKEN = SCENE.replace("sphere 0.7", "shpere 0.7")
BROKEN_LINE = 1 + BROKEN.split("\n").index("shpere 0.7 1.2 0 -4")
OTHER = SCENE.replace("background 0.2 0.3 0.5", "background 0.7 0.3 0.1")
