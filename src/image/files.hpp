#pragma once

/// Every picture format, in one include.
///
/// Writers: a file appears whole or not at all (temporary file in the same folder, then rename); "-" is
/// standard output. They demand a picture that is not empty and throw Error (write) with the path and the
/// system's reason.
///
/// Readers: "-" is standard input. They throw Error (read) with the path, what is wrong and what to do; they
/// never crash, hang or allocate more than the file can honestly fill, and refuse sides above max_image_side.

#include "file_bytes.hpp"
#include "npy.hpp"
#include "pfm.hpp"
#include "png.hpp"
#include "ppm.hpp"
