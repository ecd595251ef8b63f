for i=1 10 ' (expect alarm LB0009 column 9 says TO expected)
next
