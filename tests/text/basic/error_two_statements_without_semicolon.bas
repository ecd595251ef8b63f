x=1 y=2 ' (expect alarm LB0001 column 5 says syntax error)
