x 3 ' (expect alarm LB0015 column 1 says unknown command)
