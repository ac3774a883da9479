// Copies checked values of the case file into the structs of model/case.hpp; schema_*.cpp binds keys to
// fields.
#include <stdexcept>
#include <utility>

#include "hawser/model/schema.hpp"

namespace hawser::model {

Refusal::Refusal(const Value& at, std::string key, const std::string& text)
    : runtime_error(text), line(at.line), where(std::move(key)) {}

void refuse(const Value& v, const std::string& text) { throw Refusal(v, v.where, text); }

void refuse_key(const Value& at, const std::string& key, const std::string& text) {
  throw Refusal(at, key, text);
}

namespace {

void fill(const Key& key, const Value& v, const Target& target) {
  try {
    for (const Put& put : key.fields) put(target, v);
  } catch (const std::invalid_argument& e) {
    refuse(v, e.what());
  }
}

}  // namespace

// Keys are taken in the order of the schema, independent of the file.
void take(const Value& v, const Target& target, bool given) {
  if (v.schema->type != Key::Type::map) return fill(*v.schema, v, target);
  for (const Key& key : v.schema->keys) {
    const Value* x = v.find(key.name);
    if (!x || (given && !x->given)) continue;
    if (key.fields.empty())
      take(*x, target);
    else
      fill(key, *x, target);
  }
}

}  // namespace hawser::model
