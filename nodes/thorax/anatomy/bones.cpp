#include <pleura/nodes/thorax/anatomy/bones.h>

namespace pleura {

TriangleMesh merged(const std::vector<const TriangleMesh*>& meshes) {
  TriangleMesh all;
  for (const TriangleMesh* mesh : meshes) {
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), mesh->points.begin(), mesh->points.end());
    for (const Eigen::Vector3i& t : mesh->triangles) all.triangles.push_back(t.array() + first);
  }
  return all;
}

SurfaceQuery bonesOf(const Anatomy& anatomy) {
  std::vector<const TriangleMesh*> meshes{&anatomy.sternum.mesh};
  for (const Rib& rib : anatomy.ribs) meshes.push_back(&rib.mesh);
  for (const Cartilage& cartilage : anatomy.cartilages) meshes.push_back(&cartilage.mesh);
  for (const Vertebra& vertebra : anatomy.vertebrae) {
    meshes.push_back(&vertebra.bone);
    meshes.push_back(&vertebra.disc);
  }
  const TriangleMesh bones = merged(meshes);
  return SurfaceQuery(bones.points, bones.triangles);
}

}  // namespace pleura
