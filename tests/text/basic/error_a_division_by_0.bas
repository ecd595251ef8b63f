x=1/0 ' (expect alarm LB0016 column 4 says division by zero)
