x=acos(-2) ' (expect alarm LB0018 at acos)
