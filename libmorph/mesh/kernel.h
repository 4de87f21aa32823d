#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/Traits.hh>

namespace morph {

/// Double precision coordinates; each halfedge also knows its predecessor.
struct KernelTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};

/// The one halfedge structure of the project: triangles and quads, planar or surface.
using Kernel = OpenMesh::PolyMesh_ArrayKernelT<KernelTraits>;

using VertexHandle = Kernel::VertexHandle;
using HalfedgeHandle = Kernel::HalfedgeHandle;
using EdgeHandle = Kernel::EdgeHandle;
using FaceHandle = Kernel::FaceHandle;

} // namespace morph
