#include "features/edit/internal/refusing.hpp"

namespace kerf::features {

Editing<contour::Edge> element_of(const Outline& outline, std::size_t element) {
  if (const contour::Edge* const edge = outline.find(element)) return *edge;
  if (element < outline.size()) {
    return refused(base::Code::edit_element_unknown,
                   element_text(outline, element) + " IS NO LONGER THERE");
  }
  const std::string has =
      outline.size() == 0 ? " HAS NO ELEMENTS" : " HAS 0 TO " + std::to_string(outline.size() - 1);
  return refused(base::Code::edit_element_unknown,
                 "NO " + element_text(outline, element) + ": THE CONTOUR" + has);
}

}  // namespace kerf::features
