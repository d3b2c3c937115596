#pragma once

#include <vector>

namespace pleura {
namespace planar {

/// One side of the chest in a coronal section: wall, diaphragm and mediastinum in one closed outline, and the
/// lung in it. All lengths of the outline scale with width and height; the hilum is the origin of y.
struct HemithoraxShape {
  double width = 0.13;           // [m] from the hilum to the farthest point of the lateral wall, > 0
  double height = 0.24;          // [m] from the costophrenic recess to the apex, > 0
  double domeHeight = 0.045;     // [m] of the diaphragm's dome above the recess, in (0, height / 3]
  double midlineToHilum = 0.03;  // [m] half of the mediastinum, >= 0
  double naturalScale = 0.84;    // unstretched lengths of the lung over the cavity's, in [0.3, 1)
  double film = 0.001;           // [m] distance at which the two pleurae begin to press on each other, > 0
  double woundHeight = 0.02;     // [m] of the wound's middle above the hilum, on the lateral wall
  double woundLength = 0.02;     // [m] of the gap along the wall, >= 0
  int rings = 5;                 // of triangles from the middle of the lung to its outline, in [3, 48]
  bool isMirrored = false;       // false: on the side of +x, the subject's left
};

/// Linear viscoelastic tissue: stress = C (strain + relaxationTime * strain rate).
struct LungTissue {
  double youngsModulus = 1600;   // [Pa] > 0; with the scale above the lung fills its cavity at -5 cmH2O
  double poissonsRatio = 0.3;    // in (-1, 0.5)
  double density = 250;          // [kg/m^3] > 0, of tissue and air together
  double relaxationTime = 0.05;  // [s] >= 0
};

/// A lung and its side of the chest.
struct SideParameters {
  HemithoraxShape shape;
  LungTissue tissue;
};

/// One of the chest's two degrees of freedom, m q'' + c q' + k q = force; q = 0 is its own rest.
struct ChestCoordinate {
  double mass;       // [kg] > 0
  double damping;    // [N s/m] >= 0
  double stiffness;  // [N/m] > 0
};

}  // namespace planar

/// All of the model, in SI. Of the figures for the chest none was measured: they were chosen so that a
/// pneumothorax moves its wall out by about 1 cm and a breath takes its time from chest and lung alike.
struct PlanarLungParameters {
  // Any number, 0 too: they know each other by the chest alone.
  std::vector<planar::SideParameters> lungs = std::vector<planar::SideParameters>(1);
  planar::ChestCoordinate diaphragm{0.3, 120, 270};  // q > 0: the dome's middle goes down
  planar::ChestCoordinate chestWall{2, 385, 850};    // q > 0: the lower lateral wall goes out
  double thickness = 0.08;                           // [m] > 0, from front to back, of lung and pleural space
  double intrapleuralPressure = -490.3325;           // [Pa] gauge, at the start of the breath: -5 cmH2O
  double ambientPressure = 101325;                   // [Pa] absolute, > 0; that of the air in the lung
  double contactPressure = 300;  // [Pa] > 0: the pleurae press with 1.2 of it at half the film
};

}  // namespace pleura
