speed(0) ' (expect alarm LB0018 column 1 says argument out of domain)
