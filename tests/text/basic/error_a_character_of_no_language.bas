  y = 3 $ 4 ' (expect alarm LB0026 column 9 says illegal character)
