let =3 ' (expect alarm LB0005 column 5 says not a variable)
