next ' (expect alarm LB0011 column 1 says next without for)
