a: x=1
a: y=2 ' (expect alarm LB0007 column 1 says duplicate label)
