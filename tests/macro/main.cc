#define BOOST_TEST_MODULE macro
#include <boost/test/unit_test.hpp>
