#include <pleura/nodes/standard/core/metadata_boolean.h>
#include <pleura/nodes/standard/core/metadata_double.h>
#include <pleura/nodes/standard/core/metadata_float.h>
#include <pleura/nodes/standard/core/metadata_integer.h>
#include <pleura/nodes/standard/core/metadata_set.h>
#include <pleura/nodes/standard/core/metadata_string.h>
#include <pleura/nodes/standard/core/world_info.h>
#include <pleura/nodes/standard/environmental_effects/background.h>
#include <pleura/nodes/standard/environmental_effects/fog.h>
#include <pleura/nodes/standard/eventutilities/boolean_filter.h>
#include <pleura/nodes/standard/eventutilities/boolean_sequencer.h>
#include <pleura/nodes/standard/eventutilities/boolean_toggle.h>
#include <pleura/nodes/standard/eventutilities/boolean_trigger.h>
#include <pleura/nodes/standard/eventutilities/integer_sequencer.h>
#include <pleura/nodes/standard/eventutilities/integer_trigger.h>
#include <pleura/nodes/standard/eventutilities/time_trigger.h>
#include <pleura/nodes/standard/geometry3d/box.h>
#include <pleura/nodes/standard/geometry3d/cone.h>
#include <pleura/nodes/standard/geometry3d/cylinder.h>
#include <pleura/nodes/standard/geometry3d/indexed_face_set.h>
#include <pleura/nodes/standard/geometry3d/sphere.h>
#include <pleura/nodes/standard/grouping/group.h>
#include <pleura/nodes/standard/grouping/static_group.h>
#include <pleura/nodes/standard/grouping/switch.h>
#include <pleura/nodes/standard/grouping/transform.h>
#include <pleura/nodes/standard/interpolation/color_interpolator.h>
#include <pleura/nodes/standard/interpolation/coordinate_interpolator.h>
#include <pleura/nodes/standard/interpolation/coordinate_interpolator2d.h>
#include <pleura/nodes/standard/interpolation/normal_interpolator.h>
#include <pleura/nodes/standard/interpolation/orientation_interpolator.h>
#include <pleura/nodes/standard/interpolation/position_interpolator.h>
#include <pleura/nodes/standard/interpolation/position_interpolator2d.h>
#include <pleura/nodes/standard/interpolation/scalar_interpolator.h>
#include <pleura/nodes/standard/keydevicesensor/key_sensor.h>
#include <pleura/nodes/standard/keydevicesensor/string_sensor.h>
#include <pleura/nodes/standard/lighting/directional_light.h>
#include <pleura/nodes/standard/lighting/point_light.h>
#include <pleura/nodes/standard/lighting/spot_light.h>
#include <pleura/nodes/standard/navigation/billboard.h>
#include <pleura/nodes/standard/navigation/collision.h>
#include <pleura/nodes/standard/navigation/lod.h>
#include <pleura/nodes/standard/navigation/navigation_info.h>
#include <pleura/nodes/standard/navigation/ortho_viewpoint.h>
#include <pleura/nodes/standard/navigation/viewpoint.h>
#include <pleura/nodes/standard/navigation/viewpoint_group.h>
#include <pleura/nodes/standard/networking/anchor.h>
#include <pleura/nodes/standard/networking/inline.h>
#include <pleura/nodes/standard/register.h>
#include <pleura/nodes/standard/rendering/color.h>
#include <pleura/nodes/standard/rendering/color_rgba.h>
#include <pleura/nodes/standard/rendering/coordinate.h>
#include <pleura/nodes/standard/rendering/coordinate_double.h>
#include <pleura/nodes/standard/rendering/indexed_line_set.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_fan_set.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_set.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_strip_set.h>
#include <pleura/nodes/standard/rendering/line_set.h>
#include <pleura/nodes/standard/rendering/normal.h>
#include <pleura/nodes/standard/rendering/point_set.h>
#include <pleura/nodes/standard/rendering/triangle_set.h>
#include <pleura/nodes/standard/shape/appearance.h>
#include <pleura/nodes/standard/shape/line_properties.h>
#include <pleura/nodes/standard/shape/material.h>
#include <pleura/nodes/standard/shape/point_properties.h>
#include <pleura/nodes/standard/shape/shape.h>
#include <pleura/nodes/standard/shape/two_sided_material.h>
#include <pleura/nodes/standard/shape/unlit_material.h>
#include <pleura/nodes/standard/text/font_style.h>
#include <pleura/nodes/standard/text/text.h>
#include <pleura/nodes/standard/texturing/texture_coordinate.h>
#include <pleura/nodes/standard/time/time_sensor.h>

namespace pleura {

void registerStandardNodes(NodeRegistry& registry) {
  registry.add<Anchor>();
  registry.add<Appearance>();
  registry.add<Background>();
  registry.add<Billboard>();
  registry.add<BooleanFilter>();
  registry.add<BooleanSequencer>();
  registry.add<BooleanToggle>();
  registry.add<BooleanTrigger>();
  registry.add<Box>();
  registry.add<Collision>();
  registry.add<Color>();
  registry.add<ColorInterpolator>();
  registry.add<ColorRGBA>();
  registry.add<Cone>();
  registry.add<Coordinate>();
  registry.add<CoordinateDouble>();
  registry.add<CoordinateInterpolator>();
  registry.add<CoordinateInterpolator2D>();
  registry.add<Cylinder>();
  registry.add<DirectionalLight>();
  registry.add<Fog>();
  registry.add<FontStyle>();
  registry.add<Group>();
  registry.add<IndexedFaceSet>();
  registry.add<IndexedLineSet>();
  registry.add<IndexedTriangleFanSet>();
  registry.add<IndexedTriangleSet>();
  registry.add<IndexedTriangleStripSet>();
  registry.add<Inline>();
  registry.add<IntegerSequencer>();
  registry.add<IntegerTrigger>();
  registry.add<KeySensor>();
  registry.add<LOD>();
  registry.add<LineProperties>();
  registry.add<LineSet>();
  registry.add<Material>();
  registry.add<MetadataBoolean>();
  registry.add<MetadataDouble>();
  registry.add<MetadataFloat>();
  registry.add<MetadataInteger>();
  registry.add<MetadataSet>();
  registry.add<MetadataString>();
  registry.add<NavigationInfo>();
  registry.add<Normal>();
  registry.add<NormalInterpolator>();
  registry.add<OrientationInterpolator>();
  registry.add<OrthoViewpoint>();
  registry.add<PointLight>();
  registry.add<PointProperties>();
  registry.add<PointSet>();
  registry.add<PositionInterpolator>();
  registry.add<PositionInterpolator2D>();
  registry.add<ScalarInterpolator>();
  registry.add<Shape>();
  registry.add<Sphere>();
  registry.add<SpotLight>();
  registry.add<StaticGroup>();
  registry.add<StringSensor>();
  registry.add<Switch>();
  registry.add<Text>();
  registry.add<TextureCoordinate>();
  registry.add<TimeSensor>();
  registry.add<TimeTrigger>();
  registry.add<Transform>();
  registry.add<TriangleSet>();
  registry.add<TwoSidedMaterial>();
  registry.add<UnlitMaterial>();
  registry.add<Viewpoint>();
  registry.add<ViewpointGroup>();
  registry.add<WorldInfo>();
}

}  // namespace pleura
