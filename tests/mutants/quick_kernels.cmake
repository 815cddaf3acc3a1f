# Compiles packet code with little optimisation, which takes a third of the time; run.py includes this file.
function(quick_kernels)
  foreach(target penumbra_kernel_avx2 lane_probes_avx2)
    target_compile_options(${target} PRIVATE -O1)
  endforeach()
endfunction()
cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL quick_kernels)
