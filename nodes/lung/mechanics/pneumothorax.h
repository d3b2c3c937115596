#pragma once

#include <pleura/nodes/lung/mechanics/orifice.h>
#include <pleura/nodes/lung/mechanics/respiratory_units.h>

namespace pleura {

/// How gas gets into the pleural space. Where no source is named the rule is this model's own.
enum class Pneumothorax {
  none,    // Nothing comes in and nothing leaves; gas that is there stays until a drain has taken it.
  closed,  // A leak that has sealed: what came in (admitGas) stays, and stretches and shrinks with P V
           // constant (simple pneumothorax, DeCarlo et al. 1995, whose gas brings the space to atmospheric
           // pressure).
  open,    // A wound of the chest wall: gas flows both ways through its area, so that intrapleural pressure
         // tends to atmospheric and the lung to its unstretched shape (DeCarlo et al. 1995; the orifice's law
         // is ours).
  tension,  // A one-way valve: gas comes in while the pressure of its source is the higher, and never leaves.
            // The limit: none comes in once intrapleural pressure is its source's at the top of the breath;
            // what it rises to from there is what the next exhale makes of that gas.
};

/// What a tension pneumothorax gets its gas from.
enum class LeakSource {
  wound,  // the air outside
  lung,   // the alveoli: the transpulmonary pressure drives the gas out of a torn lung
};

struct PleuralLeak {
  Pneumothorax kind = Pneumothorax::none;
  Orifice hole;
  LeakSource source = LeakSource::wound;  // of a tension pneumothorax; an open one is a wound
};

/// A tube out of the pleural space, one way (as under a water seal). It flows while intrapleural pressure is
/// above -suction, by (p + suction) / resistance, until the gas is gone; the liquid film stays.
struct PleuralDrain {
  bool isOn = false;
  double suction = 20 * kCmH2O;  // [Pa] below ambient, >= 0; the default is the rule of this model
  double resistance = 1e7;       // [Pa s/m^3] > 0, of the tube
};

}  // namespace pleura
