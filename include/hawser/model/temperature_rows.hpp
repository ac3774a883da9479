// Mean of a change of temperature that is given by rows.
#pragma once

#include <utility>
#include <vector>

namespace hawser::model {

// Mean over the arc lengths [from, to], m, of a broken line of arc lengths [m] and changes [K]; 0: no rows.
double mean_temperature_change(const std::vector<std::pair<double, double>>& rows, double from, double to);

}  // namespace hawser::model
