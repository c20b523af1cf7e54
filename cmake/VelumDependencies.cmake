# The libraries velum stands on. Installed packages are used; with VELUM_FETCH_DEPENDENCIES=ON those that are
# missing are downloaded (header-only, all of them). A downloaded GLM cannot be part of velum's exported
# targets, so there are no install rules then.
if(NOT VELUM_FETCH_DEPENDENCIES)
  find_package(glm REQUIRED)
  find_package(FastFloat REQUIRED)
  find_path(STB_INCLUDE_DIR NAMES stb_image.h PATH_SUFFIXES stb REQUIRED)
  return()
endif()

include(FetchContent)

# The sources only: the libraries' own build files would add targets and tests that nobody here needs.
function(velum_fetch_headers name url variable)
  FetchContent_Declare(${name} URL ${url} SOURCE_SUBDIR no-build-files DOWNLOAD_EXTRACT_TIMESTAMP ON)
  FetchContent_MakeAvailable(${name})
  set(${variable} ${${name}_SOURCE_DIR} PARENT_SCOPE)
endfunction()

find_package(glm QUIET)
if(NOT TARGET glm::glm)
  velum_fetch_headers(velum_glm https://github.com/g-truc/glm/archive/refs/tags/0.9.9.8.tar.gz velum_glm_dir)
  add_library(velum_glm INTERFACE)
  target_include_directories(velum_glm SYSTEM INTERFACE ${velum_glm_dir})
  add_library(glm::glm ALIAS velum_glm)
  set(VELUM_INSTALL OFF)
endif()

find_package(FastFloat QUIET)
if(NOT TARGET FastFloat::fast_float)
  velum_fetch_headers(velum_fast_float https://github.com/fastfloat/fast_float/archive/refs/tags/v3.9.0.tar.gz velum_fast_float_dir)
  add_library(velum_fast_float INTERFACE)
  target_include_directories(velum_fast_float SYSTEM INTERFACE ${velum_fast_float_dir}/include)
  add_library(FastFloat::fast_float ALIAS velum_fast_float)
endif()

find_path(STB_INCLUDE_DIR NAMES stb_image.h PATH_SUFFIXES stb)
if(NOT STB_INCLUDE_DIR)
  velum_fetch_headers(velum_stb https://github.com/nothings/stb/archive/8b5f1f37b5b75829fc72d38e7b5d4bcbf8a26d55.tar.gz velum_stb_dir)
  set(STB_INCLUDE_DIR ${velum_stb_dir})
endif()
