print "a" "b" ' (expect alarm LB0001 column 11)
