x=(1+2 ' (expect alarm LB0002 column 3 says unbalanced parentheses)
