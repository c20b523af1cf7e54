# The libraries velum stands on. Debian's packages are found first; VELUM_FETCH_DEPENDENCIES=ON fetches
# what is missing (untested offline).
find_package(glm REQUIRED)
find_package(FastFloat REQUIRED)
find_package(Eigen3 REQUIRED)
find_path(STB_INCLUDE_DIR NAMES stb_image.h PATH_SUFFIXES stb REQUIRED)
