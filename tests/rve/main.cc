#define BOOST_TEST_MODULE rve
#include <boost/test/unit_test.hpp>
