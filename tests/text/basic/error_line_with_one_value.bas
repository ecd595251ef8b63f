line(1) ' (expect alarm LB0017 column 1 says wrong number of arguments)
