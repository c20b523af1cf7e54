# velum_strict(TARGET): our own warnings and sanitizers, for targets of this project only.
# What changes bytes (-ffp-contract=off) is not here: it is an interface option of velum::velum.
function(velum_strict target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  # GCC 12 sees overlapping copies in "text" + std::string where there are none (GCC bug 105651).
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(VELUM_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(VELUM_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${VELUM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC $<BUILD_INTERFACE:-fsanitize=${VELUM_SANITIZE}>)
  endif()
endfunction()
