x=1e999 ' (expect alarm LB0021 at 1e999)
