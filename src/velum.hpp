#pragma once

/// velum: which surface is seen at each pixel, and how deep? This header has the whole public library.
/// A scene and a camera go in, a Picture comes out; pipeline/stages.hpp is the map of the way there.

#ifdef __FAST_MATH__
#error "velum promises the same bytes everywhere; it cannot keep that under -ffast-math. Build without it."
#endif

#include "base/aabb.hpp"
#include "base/counters.hpp"
#include "base/elementary.hpp"
#include "base/error.hpp"
#include "base/executor.hpp"
#include "base/isa.hpp"
#include "clipping/clip_polygon.hpp"
#include "clipping/clip_segment.hpp"
#include "drawing/canvas.hpp"
#include "drawing/clip_drawing.hpp"
#include "drawing/pixel_drawing.hpp"
#include "drawing/sheet.hpp"
#include "image/compare.hpp"
#include "image/files.hpp"
#include "image/heat_map.hpp"
#include "image/image.hpp"
#include "image/texture.hpp"
#include "pipeline/clip_trace.hpp"
#include "pipeline/explain_pixel.hpp"
#include "pipeline/pick.hpp"
#include "pipeline/render.hpp"
#include "pipeline/trace_triangle.hpp"
#include "projection/camera.hpp"
#include "projection/frame.hpp"
#include "projection/plane_projection.hpp"
#include "projection/projection.hpp"
#include "scene/builtin.hpp"
#include "scene/load_scene.hpp"
#include "scene/scene.hpp"
#include "visibility/depth_resolution.hpp"
