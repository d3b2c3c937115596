#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include <pleura/fields/auto_update.h>
#include <pleura/fields/event_collecting_field.h>
#include <pleura/fields/field_types.h>
#include <pleura/fields/typed_field.h>
#include <pleura/tests/fields/model/reference_graph.h>

namespace pleura::model {

/// The same graph as a ReferenceGraph, of real fields.
class FieldGraph {
 public:
  std::vector<int> updates;  // which field was updated, in order

  explicit FieldGraph(int count) : slots_(static_cast<std::size_t>(count)) {}

  SFInt32& at(int i) { return *slot(i).field; }
  /// -1 when nothing is pending.
  int senderOf(int i) { return find(slot(i).probe->sender()); }

  void replace(int i, FieldKind kind) {
    slot(i).field.reset();
    using Sum = TypedField<SFInt32, AnyNumber<SFInt32>>;
    if (kind.isAuto && kind.isCollecting) return make<AutoUpdate<EventCollectingField<Sum>>>(i, kind);
    if (kind.isAuto) return make<AutoUpdate<SFInt32>>(i, kind);
    if (kind.isCollecting) return make<EventCollectingField<SFInt32>>(i, kind);
    if (kind.rule == Rule::copy) return make<SFInt32>(i, kind);
    make<Sum>(i, kind);
  }

 private:
  struct Probe {
    virtual ~Probe() = default;
    virtual const Field* sender() const = 0;
  };
  struct Slot {
    std::unique_ptr<SFInt32> field;
    Probe* probe = nullptr;
  };

  template <class Base>
  class Ruled : public Base, public Probe {
   public:
    Ruled(FieldGraph& graph, int self, FieldKind kind) : graph_(graph), self_(self), kind_(kind) {}
    const Field* sender() const override { return this->event.sender; }

    int inputs() const { return static_cast<int>(this->routes_in.size()); }
    int lastSender() const { return place(this->event.sender); }
    std::int32_t read(int i) {
      return static_cast<SFInt32*>(this->routes_in[static_cast<std::size_t>(i)])->getValue();
    }
    std::int32_t before() const { return this->value; }
    std::vector<Cause> causes() const {
      std::vector<Cause> all;
      if constexpr (requires { this->getCausingEvents(); })
        for (const Field::Event& cause : this->getCausingEvents())
          all.push_back({place(cause.sender), cause.stamp - graph_.firstStamp_});
      return all;
    }
    void setTarget(std::int32_t to) { graph_.at(kind_.target).setValue(to); }

   protected:
    void update() override {
      graph_.updates.push_back(self_);
      if (kind_.rule == Rule::copy) return Base::update();
      this->value = evaluate(kind_.rule, *this);
    }

   private:
    int place(const Field* sender) const {
      const auto& in = this->routes_in;
      return static_cast<int>(std::find(in.begin(), in.end(), sender) - in.begin());
    }

    FieldGraph& graph_;
    int self_;
    FieldKind kind_;
  };

  Slot& slot(int i) { return slots_[static_cast<std::size_t>(i)]; }

  template <class Base>
  void make(int i, FieldKind kind) {
    auto field = std::make_unique<Ruled<Base>>(*this, i, kind);
    slot(i).probe = field.get();
    slot(i).field = std::move(field);
  }

  int find(const Field* field) const {
    for (std::size_t i = 0; i < slots_.size(); ++i)
      if (slots_[i].field.get() == field) return static_cast<int>(i);
    return -1;
  }

  static std::uint64_t stampNow() {
    SFInt32 field;
    field.touch();
    return field.getStamp();
  }

  std::vector<Slot> slots_;
  std::uint64_t firstStamp_ = stampNow();  // of the process; the reference counts from here
};

}  // namespace pleura::model
