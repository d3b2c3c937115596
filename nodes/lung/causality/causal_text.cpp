#include <algorithm>
#include <array>
#include <span>

#include <pleura/nodes/lung/causality/causal_text.h>

namespace pleura {
namespace {

// What pushes a quantity up or down, as a clause after "because".
struct Push {
  Sign way = Sign::stands;
  const char* clause = "";
};

std::string joined(std::span<const Push> pushes, Sign way) {
  std::string text;
  for (const Push& push : pushes)
    if (push.way == way) text += (text.empty() ? "" : " and ") + std::string(push.clause);
  return text;
}

// "SUBJECT rises because A and B, although C."
std::string weighed(const std::string& subject, const std::string& verb, Sign change,
                    std::span<const Push> pushes, const char* still) {
  const bool stands = change == Sign::stands;
  const std::string with = joined(pushes, stands ? Sign::rises : change);
  const std::string against = joined(pushes, stands ? Sign::falls : opposite(change));
  std::string text = subject + " " + verb;
  if (stands && !with.empty() && !against.empty())
    return text + " because " + with + " while " + against + ", and the two balance.";
  if (stands) return text + (with.empty() && against.empty() ? std::string(" because ") + still : "") + ".";
  if (!with.empty()) text += " because " + with;
  if (!against.empty()) text += ", although " + against;
  return text + ".";
}

const char* byWay(Sign way, const char* falls, const char* stands, const char* rises) {
  return way == Sign::falls ? falls : way == Sign::rises ? rises : stands;
}

const char* riseVerb(Sign change) { return byWay(change, "falls", "stands", "rises"); }

Push push(Sign cause, bool isSameWay, const char* ifFalls, const char* ifRises) {
  return {isSameWay ? cause : opposite(cause), byWay(cause, ifFalls, "", ifRises)};
}

std::string muscles(const CausalChain& chain) {
  return byWay(chain.change[Quantity::muscleForce], "The breathing muscles let go.",
               "The breathing muscles hold still.", "The breathing muscles pull harder.");
}

std::string cavity(const CausalChain& chain) {
  return byWay(chain.change[Quantity::cavityVolume],
               "The chest cavity shrinks because the breathing muscles let go.",
               "The chest cavity stands because the breathing muscles hold still.",
               "The chest cavity grows because the breathing muscles pull harder.");
}

Push gasPush(const CausalChain& chain) {
  const bool isDrained = chain.isDraining && chain.pleuralGas == Sign::falls;
  return push(chain.pleuralGas, true,
              isDrained ? "the drain takes gas out of the pleural space"
                        : "gas leaves the pleural space through the wound",
              "gas comes into the pleural space");
}

// While the lung goes as the cavity does, p = P_A - P and P rises with the cavity; otherwise p V_pl ~ gas.
std::string intrapleural(const CausalChain& chain) {
  const std::array<Push, 3> pushes = {
      gasPush(chain),
      push(chain.change[Quantity::cavityVolume], false, "the chest cavity shrinks", "the chest cavity grows"),
      chain.isCoupled ? push(chain.change[Quantity::alveolar], true, "the alveolar pressure falls",
                             "the alveolar pressure rises")
                      : push(chain.change[Quantity::lungVolume], true, "the lung gives way",
                             "the lung widens into the space")};
  const Sign change = chain.change[Quantity::intrapleural];
  return weighed("The intrapleural pressure", riseVerb(change), change, pushes, "nothing about it changes");
}

std::string transpulmonary(const CausalChain& chain) {
  const std::array<Push, 2> pushes = {
      push(chain.change[Quantity::intrapleural], false, "the intrapleural pressure falls",
           "the intrapleural pressure rises"),
      push(chain.change[Quantity::alveolar], true, "the alveolar pressure falls",
           "the alveolar pressure rises")};
  const Sign change = chain.change[Quantity::transpulmonary];
  return weighed("The transpulmonary pressure", riseVerb(change), change, pushes,
                 "neither the alveolar nor the intrapleural pressure changes");
}

std::string lungVolume(const CausalChain& chain) {
  const std::array<Push, 1> pushes = {push(chain.change[Quantity::transpulmonary], true,
                                           "the transpulmonary pressure that stretches it falls",
                                           "the transpulmonary pressure that stretches it rises")};
  const Sign change = chain.change[Quantity::lungVolume];
  return weighed("The lung", byWay(change, "shrinks", "stands", "widens"), change, pushes,
                 "the transpulmonary pressure that stretches it stands");
}

// Boyle: what the air in the lung does against the lung itself.
std::string alveolar(const CausalChain& chain) {
  const Sign change = chain.change[Quantity::alveolar];
  std::string text = std::string("The alveolar pressure ") + riseVerb(change);
  if (chain.air == Sign::rises)
    return text + byWay(change, " because the lung widens faster than air comes in.",
                        " below atmospheric because air comes in as fast as the lung widens.",
                        " because air comes in faster than the lung widens.");
  if (chain.air == Sign::falls)
    return text + byWay(change, " because air goes out faster than the lung shrinks.",
                        " above atmospheric because air goes out as fast as the lung shrinks.",
                        " because the lung shrinks faster than air goes out.");
  return text + byWay(change, " because the lung begins to widen.",
                      " at atmospheric because no air moves through the open airways.",
                      " because the lung begins to shrink.");
}

std::string airFlow(const CausalChain& chain) {
  const Sign change = chain.change[Quantity::airFlow];
  if (chain.air == Sign::rises)
    return byWay(change,
                 "Air flows in, ever slower, because the alveolar pressure rises towards atmospheric.",
                 "Air flows in evenly because the alveolar pressure stands below atmospheric.",
                 "Air flows in, ever faster, because the alveolar pressure falls further below atmospheric.");
  if (chain.air == Sign::falls)
    return byWay(change,
                 "Air flows out, ever faster, because the alveolar pressure rises further above atmospheric.",
                 "Air flows out evenly because the alveolar pressure stands above atmospheric.",
                 "Air flows out, ever slower, because the alveolar pressure falls towards atmospheric.");
  return byWay(change, "Air begins to flow out because the alveolar pressure rises past atmospheric.",
               "No air flows because the alveolar pressure is atmospheric.",
               "Air begins to flow in because the alveolar pressure falls past atmospheric.");
}

bool isStill(const CausalChain& chain) {
  return chain.air == Sign::stands && std::all_of(chain.change.begin(), chain.change.end(),
                                                  [](Sign change) { return change == Sign::stands; });
}

std::string phase(const CausalChain& chain) {
  if (isStill(chain))
    return chain.pleuralGauge == Sign::falls
               ? "Nothing moves: the airways are open, so the alveolar pressure is atmospheric, and the "
                 "recoil "
                 "of the lung is held by the intrapleural pressure below it."
               : "Nothing moves: the airways are open, so the alveolar pressure is atmospheric, and no "
                 "intrapleural pressure below it holds the lung open.";
  if (!chain.isTurning) return "";
  return chain.change[Quantity::airFlow] == Sign::falls
             ? "The breath turns to expiration: the lung no longer widens, the alveolar pressure passes "
               "atmospheric, and air that came in begins to go out."
             : "The breath turns to inspiration: the lung no longer shrinks, the alveolar pressure passes "
               "atmospheric, and air begins to come in.";
}

/// Why the lung does not follow the chest wall, and a sentence of what comes of it.
struct GasReason {
  std::string because;
  std::string then;
};

GasReason becauseOfGas(const CausalChain& chain) {
  if (chain.isDraining) return {"gas is between them until the drain has taken it out", ""};
  switch (chain.pneumothorax) {
    case Pneumothorax::open:
      return {"the wound lets air into the pleural space and out of it",
              "The pressure there stays near atmospheric, and the elastic lung shrinks to the size it has "
              "when nothing stretches it."};
    case Pneumothorax::tension:
      return chain.pleuralGauge == Sign::rises
                 ? GasReason{"gas that came into the pleural space cannot leave it",
                             "The pressure there is above atmospheric and presses the lung together."}
                 : GasReason{"gas comes into the pleural space and cannot leave it",
                             "The pressure there rises to atmospheric and stretches the lung less and less."};
    default:
      return {"gas that came into the pleural space lies between them",
              "The pressure there is nearer to atmospheric and stretches the lung less."};
  }
}

const char* followsThough(Following following) {
  switch (following) {
    case Following::fully:
      return "The lung still follows the chest wall, but at a distance, because ";
    case Following::partly:
      return "The lung follows the chest wall only in part because ";
    case Following::hardly:
      return "The lung no longer follows the chest wall because ";
    case Following::unasked:
      break;
  }
  return "The lung does not fill the chest cavity because ";
}

std::array<std::string, 2> gas(const CausalChain& chain) {
  if (!chain.hasGas) return {};
  const auto [because, then] = becauseOfGas(chain);
  return {followsThough(chain.following) + because + ".", then};
}

}  // namespace

std::string sentence(const CausalChain& chain, Quantity quantity) {
  switch (quantity) {
    case Quantity::muscleForce:
      return muscles(chain);
    case Quantity::cavityVolume:
      return cavity(chain);
    case Quantity::intrapleural:
      return intrapleural(chain);
    case Quantity::transpulmonary:
      return transpulmonary(chain);
    case Quantity::lungVolume:
      return lungVolume(chain);
    case Quantity::alveolar:
      return alveolar(chain);
    case Quantity::airFlow:
      return airFlow(chain);
  }
  return "";
}

std::vector<std::string> tell(const CausalChain& chain) {
  std::vector<std::string> text;
  const auto [because, then] = gas(chain);
  for (const std::string& opening : {phase(chain), because, then})
    if (!opening.empty()) text.push_back(opening);
  for (int k = 0; k < kQuantities; ++k) text.push_back(sentence(chain, static_cast<Quantity>(k)));
  return text;
}

}  // namespace pleura
