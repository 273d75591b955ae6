#include "io/keys/units.h"

#include <locale.h>
#include <udunits2.h>

#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>

#include "contact/base/error.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::io {

namespace {

struct Traits {
    std::string_view name, article_name, si_unit, example;
};

const Traits& traits(Dimension dimension) {
    static constexpr std::array<Traits, 25> all{
        {{"pure number", "a pure number", "1", "0.5"},
         {"length", "a length", "m", "40 mm"},
         {"pressure", "a pressure", "Pa", "5.2 MPa"},
         {"force", "a force", "N", "21.1 N"},
         {"angle", "an angle", "rad", "90 deg"},
         {"time", "a time", "s", "60 s"},
         {"velocity", "a velocity", "m/s", "1 mm/s"},
         {"viscosity", "a viscosity", "Pa s", "40 Pa s"},
         {"frequency", "a frequency", "Hz", "0.21 Hz"},
         {"angular frequency", "an angular frequency", "rad/s", "1.3 rad/s"},
         {"mass", "a mass", "kg", "201 g"},
         {"density", "a density", "kg/m3", "1100 kg/m3"},
         {"stiffness", "a stiffness", "N/m", "2e7 N/m"},
         {"acceleration", "an acceleration", "m/s2", "9.81 m/s2"},
         {"moment of inertia", "a moment of inertia", "kg m2", "1.7e-4 kg m2"},
         {"rotation per length", "a rotation per length", "rad/m", "0.5 rad/m"},
         {"energy per area", "an energy per area", "J/m2", "50 mJ/m2"},
         {"thermal conductivity", "a thermal conductivity", "W/(m K)", "0.2 W/(m K)"},
         {"temperature coefficient", "a temperature coefficient", "1/K", "0.003 1/K"},
         {"wear rate", "a wear rate", "m2/N", "1e-5 mm3/(N m)"},
         {"area", "an area", "m2", "58 mm2"},
         {"energy", "an energy", "J", "2.3 mJ"},
         {"pressure per length", "a pressure per length", "Pa/m", "260 MPa/mm"},
         {"specific heat", "a specific heat", "J/(kg K)", "450 J/(kg K)"},
         {"temperature", "a temperature", "degC", "20 degC"}}};
    return all[static_cast<std::size_t>(dimension)];
}

struct Free {
    void operator()(ut_system* system) const { ut_free_system(system); }
    void operator()(ut_unit* unit) const { ut_free(unit); }
    void operator()(cv_converter* converter) const { cv_free(converter); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

// UDUNITS-2 reads numbers with strtod: while this lives, the thread has a decimal point.
class PointLocale {
  public:
    PointLocale() : point_(::newlocale(LC_NUMERIC_MASK, "C", nullptr)), old_(::uselocale(point_)) {}
    ~PointLocale() {
        ::uselocale(old_);
        ::freelocale(point_);
    }
    PointLocale(const PointLocale&) = delete;
    PointLocale& operator=(const PointLocale&) = delete;

  private:
    locale_t point_, old_;
};

// UDUNITS-2 keeps parser and status in globals: every call into it holds the lock.
class UnitDatabase {
  public:
    static UnitDatabase& instance() {
        static UnitDatabase database;
        return database;
    }

    // Empty if the text is no unit.
    Owned<ut_unit> parse(const std::string& text) const {
        return Owned<ut_unit>(ut_parse(system_.get(), text.c_str(), UT_ASCII));
    }

    // Convertibility alone takes "50 percent" for an angle and "40 mm deg" for a length, since the
    // radian is dimensionless, and "5 s" for a frequency, since UDUNITS-2 takes reciprocals. The
    // definition in basic units shows it: a factor and the definition of the SI unit.
    bool has_dimension(const ut_unit* unit, Dimension dimension) const {
        const auto si = parse(std::string(traits(dimension).si_unit));
        if (!ut_are_convertible(unit, si.get())) return false;
        const std::string definition = definition_of(unit);
        const bool logarithmic = definition.ends_with(')');  // refused as no multiple, later
        return logarithmic || definition.ends_with(definition_of(si.get()));
    }

    std::mutex mutex;

  private:
    // In basic units; empty if it is too long for any of ours.
    static std::string definition_of(const ut_unit* unit) {
        std::array<char, 256> buffer{};
        const int length = ut_format(unit, buffer.data(), buffer.size(), UT_ASCII | UT_DEFINITION);
        if (length < 0 || length >= static_cast<int>(buffer.size())) return {};
        return {buffer.data(), static_cast<std::size_t>(length)};
    }

    UnitDatabase() {
        ut_set_error_message_handler(ut_ignore);
        system_.reset(ut_read_xml(nullptr));
        if (!system_)
            fail(
                "units", "", "the unit database of UDUNITS-2 cannot be read",
                "install the package libudunits2-data, or let UDUNITS2_XML_PATH name udunits2.xml");
        const auto degree = parse("arc_degree");  // UDUNITS-2 lacks the common abbreviation
        ut_map_name_to_unit("deg", UT_ASCII, degree.get());
    }

    Owned<ut_system> system_;
};

[[noreturn]] void refuse(std::string rule, Dimension dimension) {
    std::string remedy = "write ";
    remedy.append(name_of(dimension)).append(" such as ");
    throw QuantityError{std::move(rule), remedy + toml_string(example_of(dimension))};
}

// The degree sign and both micro signs in ASCII.
std::string in_ascii(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> signs{
        {{"\u00b0", "deg"}, {"\u00b5", "u"}, {"\u03bc", "u"}, {"\u00b7", "."}}};
    std::string out(text);
    for (const auto& [sign, ascii] : signs)
        for (auto at = out.find(sign); at != std::string::npos; at = out.find(sign))
            out.replace(at, sign.size(), ascii);
    return out;
}

// Products, quotients and powers of named units only: UDUNITS-2 also knows factors ("5 mm"),
// offsets ("K @ 273"), dates and logarithms, which have no business here.
bool is_plain(std::string_view unit) {
    constexpr std::size_t longest = 40;
    if (unit.size() > longest) return false;
    bool power = false;  // a digit here is an exponent
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const char c = unit[i];
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        const bool digit = c >= '0' && c <= '9';
        if (digit && (!power || (i > 0 && unit[i - 1] == '0'))) return false;
        if (digit && i > 0 && unit[i - 1] >= '0' && unit[i - 1] <= '9') return false;
        if (!letter && !digit && std::string_view(" .*/^-()").find(c) == std::string_view::npos)
            return false;
        power = letter || c == '^' || (c == '-' && power);
    }
    return true;
}

// Value of `number` units in SI units.
double converted(double number, const ut_unit* unit, const ut_unit* si, Dimension dimension) {
    const Owned<cv_converter> converter(
        ut_get_converter(const_cast<ut_unit*>(unit), const_cast<ut_unit*>(si)));
    if (!converter) refuse("the unit cannot be converted", dimension);
    const double factor = cv_convert_double(converter.get(), 1.);
    const bool proportional = cv_convert_double(converter.get(), 0.) == 0 &&
                              cv_convert_double(converter.get(), 2.) == 2 * factor;
    if (!proportional || !(factor > 0) || !std::isfinite(factor))
        refuse("the unit is not a multiple of the SI unit", dimension);
    // 1.1 mm is 1.1 / 1000, the double nearest to 0.0011; 1.1 * 0.001 need not be.
    const double divisor = std::round(1 / factor);
    return factor < 1 && 1 / divisor == factor ? number / divisor : number * factor;
}

double in_si(double number, std::string_view unit_text, Dimension dimension) {
    if (unit_text == si_unit(dimension)) return number;
    const std::string ascii = in_ascii(unit_text);
    const std::string shown = toml_string(shortened(unit_text, 40));
    if (!is_plain(ascii)) refuse(shown + " is not a unit", dimension);

    const PointLocale locale;
    UnitDatabase& database = UnitDatabase::instance();
    const std::lock_guard lock(database.mutex);
    const Owned<ut_unit> unit = database.parse(ascii);
    if (!unit) refuse(shown + " is not a unit of UDUNITS-2 (case matters: MPa, mm)", dimension);
    if (!database.has_dimension(unit.get(), dimension)) {
        for (int k = 1; k <= static_cast<int>(Dimension::rotation_per_length); ++k) {
            const auto other = static_cast<Dimension>(k);
            if (other != dimension && database.has_dimension(unit.get(), other))
                refuse(shown + " is a unit of " + std::string(traits(other).name) +
                           ", but this is " + std::string(name_of(dimension)),
                       dimension);
        }
        refuse(shown + " is not a unit of " + std::string(traits(dimension).name), dimension);
    }
    const auto si = database.parse(std::string(si_unit(dimension)));
    return converted(number, unit.get(), si.get(), dimension);
}

}  // namespace

std::string_view name_of(Dimension dimension) {
    return traits(dimension).article_name;
}
std::string_view si_unit(Dimension dimension) {
    return traits(dimension).si_unit;
}
std::string_view example_of(Dimension dimension) {
    return traits(dimension).example;
}

double parse_quantity(std::string_view text, Dimension dimension) {
    std::string_view rest = without_plus(trimmed(text));
    double number = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error == std::errc::result_out_of_range)
        refuse("the number is too large or too small for double precision", dimension);
    if (error != std::errc()) refuse("a number with a unit is due", dimension);
    if (!std::isfinite(number)) refuse("the number must be finite", dimension);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    rest = trimmed(rest);
    if (rest.empty()) refuse("the unit is missing", dimension);

    const double value = in_si(number, rest, dimension);
    if (!std::isfinite(value)) refuse("the quantity is too large for double precision", dimension);
    if (value == 0 && number != 0)
        refuse("the quantity is too small for double precision", dimension);
    return value;
}

}  // namespace tricontact::io
