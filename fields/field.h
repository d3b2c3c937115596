#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <pleura/fields/access.h>
#include <pleura/fields/field_declaration.h>
#include <pleura/fields/field_type.h>
#include <pleura/fields/route_list.h>
#include <pleura/fields/values.h>

namespace pleura {

/// What fields belong to: a node.
class FieldOwner {
 public:
  /// The DEF name, or the type's name, for messages.
  virtual std::string describe() const = 0;

 protected:
  ~FieldOwner() = default;
};

/// Who asks: a node passes its own `id` and is exempt from the access rules of its fields.
using NodeId = const FieldOwner*;

/// A container of a value and a handler of events (H3D's Field).
///
/// A change travels along the routes as an event, without the value: it marks every field downstream as out
/// of date, each once. A field takes its new value when somebody reads it: getValue() -> upToDate() ->
/// update(). The fields of one graph belong to one thread at a time.
class Field {
 public:
  /// `sender` is the field the event came from, null when nothing is pending; `stamp` grows with every change
  /// made anywhere, so that no two changes share one.
  struct Event {
    Field* sender = nullptr;
    std::uint64_t stamp = 0;
  };

  Field() = default;
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;
  virtual ~Field();

  virtual FieldType getType() const = 0;
  std::string_view getTypeName() const { return name(getType()); }

  /// Empty for a field that no node owns.
  std::string_view getName() const;
  /// "DEF.field" or "Type.field", for messages.
  std::string getFullName() const;
  FieldOwner* getOwner() const { return owner_; }
  Access getAccessType() const { return access_; }
  const FieldDeclaration* getDeclaration() const { return declaration_; }

  /// Makes this field a member of `owner`. Called by the node type's factory, once.
  void attach(FieldOwner* owner, const FieldDeclaration* declaration);
  void setAccessType(Access access) { access_ = access; }

  /// Routes this field to `to`: from now on every event here reaches `to`, at once the first one. A route
  /// that exists is left as it is. Throws RouteError when types or access do not fit; nothing has changed
  /// then.
  void route(Field& to, NodeId id = nullptr);
  void route(Field* to, NodeId id = nullptr) { route(*to, id); }
  /// The same without the first event.
  void routeNoEvent(Field& to, NodeId id = nullptr);
  void routeNoEvent(Field* to, NodeId id = nullptr) { routeNoEvent(*to, id); }
  /// Ends the route; what is pending from here at `to` is cancelled, the value stays. No route: nothing
  /// happens.
  void unroute(Field& to);
  void unroute(Field* to) { unroute(*to); }
  bool routesTo(const Field& to) const;
  bool routesTo(const Field* to) const { return routesTo(*to); }
  const RouteList& getRoutesIn() const { return routes_in; }
  const RouteList& getRoutesOut() const { return routes_out; }

  /// Grows whenever the value may have changed: read the value first, then compare with the number kept from
  /// before.
  std::uint64_t getStamp() const { return event.stamp; }
  bool isUpToDate() const { return event.sender == nullptr; }
  /// Evaluates the field if an event is pending. Cycles end; chains of any length are safe.
  void upToDate() {
    if (event.sender != nullptr) evaluate();
  }
  /// Sends an event as if the value had been set.
  void touch();

  /// The value as X3D's XML encoding writes it; for a node, its DEF name.
  virtual std::string getValueAsString() = 0;
  /// Takes a value from its XML text, and sends an event. Floating-point numbers are multiplied by `scale`.
  /// Throws FieldParseError, the value untouched, when the text is none or out of the declared range;
  /// FieldAccessError as setValue.
  virtual void setValueFromString(std::string_view text, NodeId id = nullptr, double scale = 1) = 0;

 protected:
  /// Takes the new value: reads routes_in[i] or event.sender and writes `value`. Called only when an event is
  /// pending.
  virtual void update() = 0;
  /// Whether `from` may become input number `index`; if not, says in `why` what is expected.
  virtual bool acceptsInput(const Field& from, std::size_t index, std::string& why) const;
  /// Called before update() when routes have come or gone since the last time; throws MissingInputError.
  virtual void checkInputs() const {}
  /// Called for every event that arrives where observesEvents() was asked for. May only take notes.
  virtual void observe(Event) {}
  /// What `sender` (null: anybody) sent up to `stamp` is dealt with or cancelled. Called where
  /// observesEvents() was asked for.
  virtual void forgetEvents(const Field* /*sender*/, std::uint64_t /*stamp*/) {}
  /// Called after the propagation that reached an observing field has ended.
  virtual void afterEvents() {}

  void observesEvents() { observes_ = true; }
  /// Throws FieldParseError where a component of `read`, `at` bytes into the text, is outside the range that
  /// the declaration gives.
  template <class T>
  void checkRange(const T& read, std::size_t at) const {
    if (declaration_ != nullptr && declaration_->isBounded() && !declaration_->admits(read)) refuseRange(at);
  }
  [[noreturn]] void refuseRange(std::size_t at) const;
  void checkSet(NodeId id) const {
    if (!canSet(access_) && id != owner_) refuseSet();
  }
  void checkGet(NodeId id) const {
    if (!canGet(access_) && id != owner_) refuseGet();
  }

  RouteList routes_in;  // in the order they were made; update() may rely on it
  RouteList routes_out;
  Event event;

 private:
  friend class Propagation;
  void evaluate();
  void evaluatePendingInputs();
  void runUpdate();
  /// Something downstream is up to date again, or hears of it by another way: the next event has to travel.
  static void unsettle(Field* field) {
    while (field != nullptr && field->settled_) {
      field->settled_ = false;
      field = field->event.sender;
    }
  }
  [[noreturn]] void refuseSet() const;
  [[noreturn]] void refuseGet() const;
  [[noreturn]] void refuseRoute(const Field& to, const std::string& why) const;

  // Next to what an event reads and writes above.
  bool settled_ = false;  // all that is downstream is out of date already, each by way of this field
  bool observes_ = false;
  bool queued_ = false;        // waits for afterEvents()
  bool inputsChanged_ = true;  // since checkInputs() last found them right
  bool evaluating_ = false;
  Access access_ = Access::inputOutput;
  FieldOwner* owner_ = nullptr;
  const FieldDeclaration* declaration_ = nullptr;
};

}  // namespace pleura
