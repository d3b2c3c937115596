#pragma once

#include <filesystem>
#include <functional>

#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// Reads a mesh file as it is (frame and unit untouched); throws what it likes if it cannot.
using MeshLoader = std::function<TriangleMesh(const std::filesystem::path&)>;

/// The thorax made from real meshes, in mm, x left, y back, z up: DIR/skeleton/left_first_rib.obj,
/// left_first_costal_cartilage.obj, manubrium.obj, first_thoracic_vertebra.obj and so on,
/// DIR/organs/diaphragm.obj, left_lung.obj, right_lung.obj. Surfaces are repaired, landmarks found on them,
/// the diaphragm's thoracic face taken, the lungs skinned anew to fit wall and diaphragm;
/// costal cartilages 8-10 and parts whose file is missing are generated. Throws std::invalid_argument if DIR
/// has no such folder or a mesh is unusable.
Anatomy anatomyFromMeshes(const std::filesystem::path& directory, const MeshLoader& load);

}  // namespace pleura
