#pragma once

/// @file
/// All that a program needs and, with formats/formats.h, all that is public: what is not reached from these two
/// may change without notice and is not installed.

/// Everything of libmorph.
///
/// Start with read_mesh(), fit_marker() and Deformer. A mesh is a Mesh in memory and a MeshData in the numbering of
/// its file.
namespace morph {
}

// Meshes: build_mesh(), to_mesh_data(), apply_edits().
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/core/progress.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/mesh/edits.h"

// Moving a mesh: Deformer; compare() for a move by several methods; or weights of single methods, apply_weights() and control_point_gradient().
#include "libmorph/deform/apply.h"
#include "libmorph/deform/gradient.h"
#include "libmorph/deform/repair.h"
#include "libmorph/pipeline/comparison.h"
#include "libmorph/pipeline/deformer.h"
#include "libmorph/pipeline/generate.h"
#include "libmorph/weights/damping.h"
#include "libmorph/weights/fit_marker.h"
#include "libmorph/weights/harmonic_curves.h"
#include "libmorph/weights/lattice_weights.h"
#include "libmorph/weights/weight_fields.h"

// Looking at a mesh.
#include "libmorph/quality/full_quality.h"
#include "libmorph/quality/safe_step.h"

// Another mesh of the same domain, and fields from one mesh to another.
#include "libmorph/pipeline/remesh_job.h"
#include "libmorph/remap/remap.h"
#include "libmorph/remesh/remesh.h"
