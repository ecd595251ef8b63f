x=3abc ' (expect alarm LB0021 column 3 says malformed number)
