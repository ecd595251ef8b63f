x=1+2) ' (expect alarm LB0002 column 6 says unbalanced parentheses)
