#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <pleura/x3d/browser/tradeoff/shape_error.h>

namespace pleura {

/// What a tier costs and how wrong it is, for one organ.
struct TierFigures {
  std::string organ;
  std::string method;
  int elements = 0;       // of a lattice; 0: none
  double median = 0;      // [s] a shape
  double p99 = 0;         // [s]
  double setUp = 0;       // [s] once
  double memory = 0;      // [byte] kept
  bool converged = true;  // at every moment
  ShapeError error;

  /// Whether an organ may be deformed so: not the reference, nor what did not converge.
  bool isChoosable() const;
};

/// Where the figures of this machine are kept: pleura/tradeoff.csv in the user's folder for caches
/// (XDG_CACHE_HOME); empty where there is none.
std::filesystem::path keptFigures();
/// The figures of a table; none where it can't be read.
std::vector<TierFigures> readFigures(const std::filesystem::path& file);

/// A table of figures that grows by a line at a time, so that work which was interrupted goes on. `key` says
/// what was measured: a file of another key is begun anew.
class FigureTable {
 public:
  /// Reads what is there. Throws std::runtime_error when the file can't be written.
  FigureTable(std::filesystem::path file, const std::string& key);

  const std::vector<TierFigures>& all() const { return all_; }
  bool has(const std::string& organ, const std::string& method, int elements) const;
  /// Throws std::runtime_error when it can't be written.
  void add(const TierFigures& figures);

 private:
  std::filesystem::path file_;
  std::vector<TierFigures> all_;
};

}  // namespace pleura
