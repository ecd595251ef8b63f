x=sqrt(-1) ' (expect alarm LB0018 column 3 says argument out of domain)
