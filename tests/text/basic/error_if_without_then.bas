if 1 print 2 ' (expect alarm LB0008 column 6 says THEN expected)
