return ' (expect alarm LB0013 column 1 says RETURN without GOSUB)
