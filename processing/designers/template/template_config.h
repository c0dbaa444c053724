// The config of the designer that carries a curve over from a reference (docs/designers/template.md).
#pragma once

#include "processing/designers/designer_words.h"
#include "processing/designers/template/template_comparison.h"
#include "processing/designers/template/template_reference.h"

namespace echolucent {

/// parametersOf() has the ranges of the slopes too.
struct TemplateConfig {
    static constexpr DesignerWords words{"template", "Template"};
    SharedTemplate reference = fetusTemplate();  ///< no row of the table
    TemplateComparison comparison = TemplateComparison::logarithm;
    double leastSlope = 0.25;   ///< of the warp, [1/8,1]
    double largestSlope = 4.0;  ///< of the warp, [1,8]
    friend bool operator==(const TemplateConfig&, const TemplateConfig&) = default;
};

}  // namespace echolucent
