next ' (expect alarm LB0011 column 1 says NEXT without FOR)
