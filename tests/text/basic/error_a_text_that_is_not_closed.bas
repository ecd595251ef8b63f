print "abc
' (finally alarm LB0020 line 1 column 7)
