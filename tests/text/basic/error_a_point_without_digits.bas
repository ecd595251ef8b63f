x=1. ' (expect alarm LB0021 at 1.)
