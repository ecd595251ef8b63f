print (1)) ' (expect alarm LB0002 column 10)
