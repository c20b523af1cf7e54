#pragma once

#include "options.hpp"
#include "plots.hpp"
#include "ray_measure.hpp"

namespace velum_bench {

// What the program does; each prints to standard output and returns the exit code: 1 if a picture or a figure
// is not what it should be. @throws velum::Error

/// The table of frames.
int run_frames(const Options& options);
/// The goals, one line each.
int run_check(const Options& options);
/// Time over triangles and over pixels.
int run_growth(const Options& options);
/// Casting rays, with Embree beside it; a line per goal.
int run_rays(const Options& options);
/// Its part of the check. Scenes whose files are not there are left out.
RayFigures measure_ray_scenes(const Options& options);
/// What the machine itself can do.
int run_limits(const Options& options);

/// Who is measured, how, and on which machine.
std::string circumstances(const Options& options);
/// The lines over a table: machine, threads, contenders; what is not as it should be, to standard error.
void print_circumstances(const Options& options);
/// A table as the options want it.
void print(const Table& table, const Options& options);

}  // namespace velum_bench
