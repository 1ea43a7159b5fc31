#define BOOST_TEST_MODULE micro
#include <boost/test/unit_test.hpp>
