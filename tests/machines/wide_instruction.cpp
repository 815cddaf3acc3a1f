// Runs one instruction of the set named by its argument: avx, avx2 or avx512. A machine without it raises SIGILL.
#include <cstring>

int main(int argc, char** argv) {
  if (argc != 2) return 64;
  if (std::strcmp(argv[1], "avx") == 0) asm volatile("vaddps %%xmm0, %%xmm0, %%xmm0" ::: "xmm0");
  if (std::strcmp(argv[1], "avx2") == 0) asm volatile("vpaddd %%ymm0, %%ymm0, %%ymm0" ::: "xmm0");
  if (std::strcmp(argv[1], "avx512") == 0) asm volatile("vaddps %%zmm0, %%zmm0, %%zmm0" ::: "xmm0");
  return 0;
}
