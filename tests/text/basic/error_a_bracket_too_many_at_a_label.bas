goto a) ' (expect alarm LB0002 column 7)
a: end
