#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/lung/causal_chain_node.h>
#include <pleura/nodes/lung/causality/causal_text.h>

namespace pleura {

void CausalChainNode::declare(NodeType& type) {
  Node::declare(type);
  type.named("CausalChain", "Pleura").means("tells what changes in a breath and because of what");
  using enum Access;
  type.field<&CausalChainNode::space>("space", initializeOnly, {}).means("the PleuralSpace that is told of");
  type.field<&CausalChainNode::text>("text", outputOnly, {})
      .means("a sentence for each link, cause before effect; for Text.string");
  type.field<&CausalChainNode::change>("change", outputOnly, {})
      .means(
          "-1 falls, 0 stands, 1 rises: muscle force, cavity volume, intrapleural and transpulmonary "
          "pressure, "
          "lung volume, alveolar pressure, air flow");
}

void CausalChainNode::onInitialize() {
  if (space.get() == nullptr) return context().warn(*this, "space is missing: a PleuralSpace is expected");
  context().time.routeNoEvent(text, id);
  context().time.routeNoEvent(change, id);
}

CausalChain CausalChainNode::now() {
  PleuralSpace& told = *space.get();
  const LungState& state = told.now();
  const PleuralSpace::Step& step = told.lastStep();
  return step.duration > 0 ? causalChain(step.lung, step.inputs, step.before, state, step.duration)
                           : CausalChain();
}

void CausalChainNode::Text::update() { value = tell(static_cast<CausalChainNode*>(getOwner())->now()); }

void CausalChainNode::Change::update() {
  const CausalChain chain = static_cast<CausalChainNode*>(getOwner())->now();
  value.resize(kQuantities);
  for (int q = 0; q < kQuantities; ++q)
    value[static_cast<std::size_t>(q)] = static_cast<int>(chain.change[static_cast<Quantity>(q)]);
}

}  // namespace pleura
