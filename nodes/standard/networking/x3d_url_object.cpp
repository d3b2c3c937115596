#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/networking/x3d_url_object.h>

namespace pleura {

void X3DUrlObject::declare(NodeType& type) {
  using enum Access;
  type.field<&X3DUrlObject::autoRefresh>("autoRefresh", inputOutput, 0)
      .measuredIn(Unit::time)
      .atLeast(0)
      .means("time from one load to the next; 0: loaded once");
  type.field<&X3DUrlObject::autoRefreshTimeLimit>("autoRefreshTimeLimit", inputOutput, 3600)
      .measuredIn(Unit::time)
      .atLeast(0)
      .means("time after which loading again ends");
  type.field<&X3DUrlObject::description>("description", inputOutput, {})
      .means("what is loaded, told to the user");
  type.field<&X3DUrlObject::load>("load", inputOutput, true).means("whether it is loaded now");
  type.field<&X3DUrlObject::url>("url", inputOutput, {}).means("places to load from: the first that can be");
}

}  // namespace pleura
