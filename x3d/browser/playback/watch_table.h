#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <pleura/x3d/browser/scene/scene.h>

namespace pleura {

/// Fields followed over time: a row a step, the time first, then a column for each component.
class WatchTable {
 public:
  /// `paths` are "DEF.field". Throws UnknownNameError, and FieldError for a field that can't be read or a
  /// node's.
  WatchTable(Scene& scene, const std::vector<std::string>& paths);

  /// "time,BREATH.lungVolume,RIB_L1.rotation.0,..."; evaluates the fields to know how many components they
  /// have.
  void writeHeader(std::ostream& out);
  void writeRow(std::ostream& out, Time now);
  bool isEmpty() const { return fields_.empty(); }

 private:
  std::vector<std::pair<std::string, Field*>> fields_;
};

}  // namespace pleura
