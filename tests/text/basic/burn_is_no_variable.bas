local burn ' (expect alarm LB0005 at burn)
