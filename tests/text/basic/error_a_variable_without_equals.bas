x+3 ' (expect alarm LB0004 column 2 says equals sign expected)
