line(1,2,3,4) ' (expect alarm LB0017 column 1 says wrong number of arguments)
