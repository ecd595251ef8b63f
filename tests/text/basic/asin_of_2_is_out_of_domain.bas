x=asin(2) ' (expect alarm LB0018 at asin)
