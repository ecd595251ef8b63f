x=' (expect alarm LB0003 column 3 says no expression present)
